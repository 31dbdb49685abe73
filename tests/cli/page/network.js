return performance.getEntriesByType('resource').filter(entry => !/^(data|blob):/.test(entry.name)).length;
