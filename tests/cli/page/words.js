return document.body.innerText.split(/\s+/).filter(word => /[\p{L}\p{N}]/u.test(word)).length;
